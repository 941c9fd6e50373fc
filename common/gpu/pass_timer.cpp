#include "common/gpu/pass_timer.h"

#include <algorithm>

namespace eikonal::gpu {

PassTimer::PassTimer(const Context&) : frames_(1) {}

PassTimer::~PassTimer() {
    for (const Frame& frame : frames_) {
        for (const Mark& mark : frame) glDeleteQueries(1, &mark.query);
    }
    glDeleteQueries(GLsizei(free_.size()), free_.data());
}

void PassTimer::mark(std::string_view pass) {
    GLuint query = 0;
    if (free_.empty()) {
        glCreateQueries(GL_TIMESTAMP, 1, &query);
    } else {
        query = free_.back();
        free_.pop_back();
    }
    glQueryCounter(query, GL_TIMESTAMP);
    glFlush();  // Mesa's software renderer looks at the clock when it is flushed, and runs dispatches at once
    frames_.back().push_back({std::string(pass), query});
}

bool PassTimer::isDone(const Frame& frame) const {
    if (frame.empty()) return true;
    GLint available = GL_FALSE;
    glGetQueryObjectiv(frame.back().query, GL_QUERY_RESULT_AVAILABLE, &available);
    return available == GL_TRUE;
}

void PassTimer::takeIn(const Frame& frame) {
    for (const Mark& mark : frame) {
        for (auto& [pass, seconds] : seconds_) seconds = pass == mark.pass ? 0.0 : seconds;
    }
    GLuint64 before = 0;
    for (std::size_t i = 0; i < frame.size(); ++i) {
        GLuint64 now = 0;
        glGetQueryObjectui64v(frame[i].query, GL_QUERY_RESULT, &now);
        if (i > 0 && !frame[i - 1].pass.empty()) {
            const std::string& pass = frame[i - 1].pass;
            auto row = std::find_if(seconds_.begin(), seconds_.end(), [&](const auto& r) { return r.first == pass; });
            if (row == seconds_.end()) row = seconds_.emplace(seconds_.end(), pass, 0.0);
            row->second += double(now - before) * 1e-9;
        }
        before = now;
    }
}

void PassTimer::endFrame() {
    frames_.emplace_back();
    while (frames_.size() > 1 && isDone(frames_.front())) {
        if (!frames_.front().empty()) takeIn(frames_.front());
        for (const Mark& mark : frames_.front()) free_.push_back(mark.query);
        frames_.pop_front();
    }
}

} // namespace eikonal::gpu
