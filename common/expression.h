#pragma once
// Expressions of a scene file: optical constants as formulas of position.

#include <memory>
#include <string>

#include <glm/glm.hpp>

#include "common/scene.h"

namespace eikonal {

/// A formula in x, y, z and r = |(x, y, z)|, for example "r < 1 ? sqrt(2 - r*r) : 1".
/// Not thread-safe: threads make one each, which costs tens of microseconds.
class Expression {
public:
    /// `where` is the position of the opening quote in the scene file: errors point at the character behind it.
    /// Throws badInput for a syntax error, an unknown name, an assignment or a list.
    Expression(const std::string& text, const SourcePosition& where);
    ~Expression();
    Expression(Expression&&) noexcept;
    Expression& operator=(Expression&&) noexcept;

    /// The value at a point; infinite or NaN where the formula is (1/0), which callers reject.
    double operator()(const glm::dvec3& point) const;

    const std::string& text() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Names that expressions may use besides muParser's own, for documentation and messages.
std::string expressionFunctions();

} // namespace eikonal
