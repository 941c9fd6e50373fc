#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <tbb/parallel_for.h>

#include "common/expression.h"
#include "tests/common/scene_text.h"

namespace eikonal {
namespace {

const SourcePosition kQuote{"s.toml", 3, 7};

double evaluate(const std::string& text, const glm::dvec3& point) { return Expression(text, kQuote)(point); }

std::string errorOfExpression(const std::string& text) {
    return messageOf([&] { Expression(text, kQuote); });
}

TEST(Expression, KnowsPositionAndDistanceToTheOrigin) {
    const glm::dvec3 p(1.0, 2.0, -2.0);
    EXPECT_DOUBLE_EQ(evaluate("x + 10*y + 100*z", p), 1.0 + 20.0 - 200.0);
    EXPECT_DOUBLE_EQ(evaluate("r", p), 3.0);
}

TEST(Expression, KnowsTheUsualFunctions) {
    const glm::dvec3 p(0.3, 0.4, 0.0);
    EXPECT_DOUBLE_EQ(evaluate("sqrt(2 - r*r)", p), std::sqrt(2.0 - 0.25));
    EXPECT_DOUBLE_EQ(evaluate("0.5*erfc(x/sqrt(2))", p), 0.5 * std::erfc(0.3 / std::numbers::sqrt2));
    EXPECT_DOUBLE_EQ(evaluate("exp(-y) + pow(x, 2) + x^2 + cos(pi)", p), std::exp(-0.4) + 0.09 + 0.09 - 1.0);
    EXPECT_DOUBLE_EQ(evaluate("clamp(y, 0, 0.1) + mod(-0.25, 1) + smoothstep(0, 2, 1)", p), 0.1 + 0.75 + 0.5);
    EXPECT_DOUBLE_EQ(evaluate("r < 1 && x == 0.3 ? 2 : 3", p), 2.0);
}

TEST(Expression, DivisionByZeroIsInfiniteForTheCallerToReject) {
    EXPECT_TRUE(std::isinf(evaluate("1/r", glm::dvec3(0.0))));
    EXPECT_TRUE(std::isnan(evaluate("sqrt(-1 - r)", glm::dvec3(0.0))));
}

TEST(Expression, RefusesAssignmentAtItsColumn) {
    // Column 7 is the quote, so the first character stands in column 8 and '=' in column 10.
    const std::string message = errorOfExpression("x = 3");
    EXPECT_NE(message.find("s.toml:3:10"), std::string::npos) << message;
    EXPECT_NE(message.find("expected a comparison"), std::string::npos) << message;
    EXPECT_DOUBLE_EQ(evaluate("x >= 1 ? 1 : 0", glm::dvec3(1.0, 0.0, 0.0)), 1.0);
    EXPECT_DOUBLE_EQ(evaluate("x != 1 ? 1 : 0", glm::dvec3(1.0, 0.0, 0.0)), 0.0);
}

TEST(Expression, RefusesSyntaxErrorsUnknownNamesAndLists) {
    EXPECT_NE(errorOfExpression("1 + foo*x").find("s.toml:3:12"), std::string::npos) << errorOfExpression("1 + foo*x");
    EXPECT_NE(errorOfExpression("1 + "), "no error");
    EXPECT_NE(errorOfExpression(""), "no error");
    EXPECT_NE(errorOfExpression("sin(x"), "no error");
    EXPECT_NE(errorOfExpression("1, 2").find("expected one value, found 2"), std::string::npos);
}

TEST(Expression, EachThreadMayHaveItsOwn) {
    std::vector<double> values(2000, 0.0);
    tbb::parallel_for(0, 20, [&](int chunk) {
        const Expression expression("x*x + sin(y)", kQuote);
        for (int i = 100 * chunk; i < 100 * (chunk + 1); ++i)
            values[std::size_t(i)] = expression(glm::dvec3(i, 0.5, 0.0));
    });
    for (int i = 0; i < 2000; ++i)
        ASSERT_DOUBLE_EQ(values[std::size_t(i)], double(i) * double(i) + std::sin(0.5));
}

} // namespace
} // namespace eikonal
