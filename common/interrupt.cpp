#include "common/interrupt.h"

#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <cstring>

#include <unistd.h>

#include "common/error.h"

namespace eikonal {
namespace {

// Handlers may touch lock-free atomics and plain bytes only; hence a fixed table instead of a container.
constexpr int kSlots = 16;
enum SlotState : int { kFree, kFilling, kReady };
struct Slot {
    std::atomic<int> state{kFree};
    std::array<char, PATH_MAX> path{};
};
std::array<Slot, kSlots> slots;
std::atomic<bool> raised{false};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

extern "C" void onSignal(int) {
    if (!raised.exchange(true))
        return;
    for (Slot& slot : slots)
        if (slot.state.load() == kReady)
            unlink(slot.path.data());
    _exit(static_cast<int>(ExitCode::kFailure));
}

} // namespace

void installInterruptHandlers() {
    struct sigaction action = {};
    action.sa_handler = onSignal;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() { return raised.load(std::memory_order_relaxed); }

void throwIfInterrupted() {
    if (interrupted())
        throw failure("interrupted");
}

int removeOnSignal(const std::filesystem::path& file) {
    const std::string& name = file.native();
    if (name.size() >= PATH_MAX)
        return -1;
    for (int i = 0; i < kSlots; ++i) {
        int expected = kFree;
        if (slots[std::size_t(i)].state.compare_exchange_strong(expected, kFilling)) {
            std::memcpy(slots[std::size_t(i)].path.data(), name.c_str(), name.size() + 1);
            slots[std::size_t(i)].state.store(kReady);
            return i;
        }
    }
    return -1;
}

void keepOnSignal(int slot) {
    if (slot >= 0)
        slots[std::size_t(slot)].state.store(kFree);
}

} // namespace eikonal
