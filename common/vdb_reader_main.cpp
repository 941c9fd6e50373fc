// The reader process: parses one VDB file within limits on memory and time and sends what it holds to standard output.
// Run by vdb_read.cpp: eikonal_vdb_reader (grids | summary) FILE. The answer starts with a tag (vdb_transfer.h).

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "common/error.h"
#include "common/vdb_parse.h"
#include "common/vdb_transfer.h"

#if defined(__SANITIZE_ADDRESS__)
#define EIKONAL_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define EIKONAL_ADDRESS_SANITIZER 1
#endif
#endif

namespace {

/// Half of the machine's memory, and never less than 2 GiB.
rlim_t memoryLimitBytes() {
    const auto physical = rlim_t(sysconf(_SC_PHYS_PAGES)) * rlim_t(sysconf(_SC_PAGESIZE));
    return std::max<rlim_t>(physical / 2, rlim_t(2) << 30);
}

/// The slowest sane file reads at some 10 MB/s; damaged ones loop for ever.
void limitResources(const std::filesystem::path& file) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    std::error_code ignored;
    const rlim_t seconds = 10 + std::filesystem::file_size(file, ignored) / 10'000'000;
    const rlimit time{seconds, seconds + 1};
    setrlimit(RLIMIT_CPU, &time);
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);
    alarm(unsigned(10 * seconds));
#ifndef EIKONAL_ADDRESS_SANITIZER  // its shadow reserves terabytes of address space
    const rlimit memory{memoryLimitBytes(), memoryLimitBytes()};
    setrlimit(RLIMIT_AS, &memory);
#endif
}

int send(const std::filesystem::path& file, bool summary) {
    if (summary) {
        const nlohmann::json answer = eikonal::summarizeVdb(file);
        std::fputc(eikonal::kDataTag, stdout);
        eikonal::sendJson(stdout, answer);
    } else {
        const eikonal::VdbFile answer = eikonal::parseVdb(file);
        std::fputc(eikonal::kDataTag, stdout);
        eikonal::sendVdb(stdout, answer);
    }
    return std::fflush(stdout) == 0 ? 0 : 1;
}

int complain(const std::string& message) {
    std::fputc(eikonal::kComplaintTag, stdout);
    std::fwrite(message.data(), 1, message.size(), stdout);
    std::fflush(stdout);
    return int(eikonal::ExitCode::kBadInput);
}

int run(const char* request, const std::filesystem::path& file) {
    try {
        limitResources(file);
        return send(file, std::strcmp(request, "summary") == 0);
    } catch (const std::bad_alloc&) {
        return complain(fmt::format("{}: reading it takes more than {:.1f} GiB of memory: too large here, or damaged",
                                    file.string(), double(memoryLimitBytes()) / double(1 << 30)));
    } catch (const eikonal::Error& e) {
        return complain(e.what());
    } catch (const std::exception& e) {
        return complain(fmt::format("{}: damaged VDB file ({})", file.string(), e.what()));
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs("usage: eikonal_vdb_reader (grids | summary) FILE\n", stderr);
        return int(eikonal::ExitCode::kUsage);
    }
    // Static destructors would run over whatever a damaged file has done to the heap.
    _exit(run(argv[1], argv[2]));
}
