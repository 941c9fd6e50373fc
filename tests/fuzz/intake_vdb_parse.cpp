#include <nlohmann/json.hpp>

#include "common/error.h"
#include "common/vdb_parse.h"
#include "tests/fuzz/intakes.h"
#include "tests/support/temporary_folder.h"

namespace eikonal::fuzz {

void parseVdbFile(Bytes bytes) {
    static const test::TemporaryFolder folder;
    const std::string file = folder.write("fuzz.vdb", std::string(bytes.begin(), bytes.end()));
    try {
        parseVdb(file);
        summarizeVdb(file);
    } catch (const std::exception&) {  // the reader process turns each into a message
    }
}

} // namespace eikonal::fuzz
