#pragma once
// What bad input must end in.

#include <string>

#include <gtest/gtest.h>

#include "common/error.h"

namespace eikonal::test {

/// Runs `action`, which must throw an Error with that code and a message with that part in it.
template <class Action>
void expectError(ExitCode code, const std::string& part, Action&& action) {
    try {
        action();
        ADD_FAILURE() << "expected an error with '" << part << "', found none";
    } catch (const Error& error) {
        EXPECT_EQ(int(error.code()), int(code)) << error.what();
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

} // namespace eikonal::test
