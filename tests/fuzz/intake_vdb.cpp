#include <cstring>

#include <nlohmann/json.hpp>

#include "common/error.h"
#include "common/vdb_io.h"
#include "common/vdb_transfer.h"
#include "tests/fuzz/intakes.h"
#include "tests/support/temporary_folder.h"

namespace eikonal::fuzz {

void readVdbFile(Bytes bytes) {
    const test::TemporaryFolder folder;
    const std::string file = folder.write("fuzz.vdb", std::string(bytes.begin(), bytes.end()));
    try {
        readVdb(file);
    } catch (const Error&) {
    }
}

void receiveVdbAnswer(Bytes bytes) {
    std::size_t next = 0;
    VdbFile file;
    receiveVdb([&](void* data, std::size_t count) {
        if (count > bytes.size() - next) {
            return false;
        }
        std::memcpy(data, bytes.data() + next, count);
        next += count;
        return true;
    }, file);
}

} // namespace eikonal::fuzz
