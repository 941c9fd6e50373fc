#include "common/scene.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

namespace eikonal {

std::string describe(const SourcePosition& position) {
    if (position.line <= 0)
        return position.file;
    return fmt::format("{}:{}:{}", position.file, position.line, position.column);
}

bool isOnCommandLine(const SourcePosition& position) { return position.line <= 0 && position.file.starts_with("--set "); }

SourcePosition Scene::placeOf(std::initializer_list<std::string> keys) const {
    for (const std::string& key : keys)
        if (const auto found = places.find(key); found != places.end() && isOnCommandLine(found->second))
            return found->second;
    const auto first = places.find(*keys.begin());
    return first == places.end() ? SourcePosition{.file = source} : first->second;
}

glm::dmat4 Object::worldFromLocal() const {
    glm::dmat4 world = glm::translate(glm::dmat4(1.0), translate);
    world = glm::rotate(world, glm::radians(rotate.z), glm::dvec3(0.0, 0.0, 1.0));
    world = glm::rotate(world, glm::radians(rotate.y), glm::dvec3(0.0, 1.0, 0.0));
    world = glm::rotate(world, glm::radians(rotate.x), glm::dvec3(1.0, 0.0, 0.0));
    return glm::scale(world, glm::dvec3(scale));
}

} // namespace eikonal
