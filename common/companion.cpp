#include "common/companion.h"

#include <system_error>

#include <fmt/format.h>

#include "common/error.h"

namespace fs = std::filesystem;

namespace eikonal {

fs::path findCompanion(const std::string& name, const fs::path& buildFolder) {
    std::error_code ignored;
    const fs::path here = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    const fs::path installed = (here / ".." / "lib" / "eikonal").lexically_normal();
    for (const fs::path& folder : {here, installed, buildFolder})
        if (fs::is_regular_file(folder / name, ignored))
            return folder / name;
    throw failure(fmt::format("a part of the program is missing: expected {} in {} or {}", name, here.string(),
                              installed.string()));
}

} // namespace eikonal
