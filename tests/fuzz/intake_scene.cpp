#include <stdexcept>

#include "common/error.h"
#include "common/scene_toml.h"
#include "tests/fuzz/intakes.h"

namespace eikonal::fuzz {

void readScene(Bytes bytes) {
    const std::string text(bytes.begin(), bytes.end());
    std::string written;
    try {
        written = resolvedToml(parseScene(text, "fuzz.toml", "."));
    } catch (const Error&) {
        return;
    }
    if (resolvedToml(parseScene(written, "written.toml", ".")) != written) {
        throw std::logic_error("a scene does not read back as it was written:\n" + written);
    }
}

} // namespace eikonal::fuzz
