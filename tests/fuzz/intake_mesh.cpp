#include <array>

#include "common/error.h"
#include "common/mesh.h"
#include "tests/fuzz/intakes.h"
#include "tests/support/temporary_folder.h"

namespace eikonal::fuzz {

void readMesh(Bytes bytes) {
    constexpr std::array kNames{"fuzz.obj", "fuzz.ply", "fuzz.stl", "fuzz.gltf", "fuzz.glb"};
    if (bytes.empty()) {
        return;
    }
    static const test::TemporaryFolder folder;
    const std::string file =
        folder.write(kNames[bytes[0] % kNames.size()], std::string(bytes.begin() + 1, bytes.end()));
    try {
        loadSolidMesh(file);
    } catch (const Error&) {
    }
}

} // namespace eikonal::fuzz
