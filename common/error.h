#pragma once
// How the program fails: wrong input, wrong usage and missing devices throw Error, caught once in main.
// Broken logic asserts; expected absence is a return value.

#include <stdexcept>
#include <string>

namespace eikonal {

/// Exit codes of the program (docs/errors.md).
enum class ExitCode { kDone = 0, kFailure = 1, kUsage = 2, kBadInput = 3, kNoDevice = 4 };

/// A failure with a message for the user: what was expected, what was found, and where.
class Error : public std::runtime_error {
public:
    Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
    ExitCode code() const { return code_; }

private:
    ExitCode code_;
};

inline Error badInput(const std::string& message) { return Error(ExitCode::kBadInput, message); }
inline Error failure(const std::string& message) { return Error(ExitCode::kFailure, message); }

} // namespace eikonal
