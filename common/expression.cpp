#include "common/expression.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <muParser.h>

#include "common/error.h"

namespace eikonal {

struct Expression::State {
    std::string text;
    mu::Parser parser;
    double x = 0.0, y = 0.0, z = 0.0, r = 0.0;
};

namespace {

Error expressionError(const SourcePosition& where, const std::string& text, std::size_t offset,
                      const std::string& what) {
    SourcePosition at = where;
    if (at.line > 0)
        at.column += 1 + int(offset);  // behind the opening quote
    return badInput(fmt::format("{}: expression \"{}\": {}", describe(at), text, what));
}

/// muParser would take `x = 3` for an assignment and change the variable.
void rejectAssignment(const std::string& text, const SourcePosition& where) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '=')
            continue;
        const bool doubled = i + 1 < text.size() && text[i + 1] == '=';
        const bool compound = i > 0 && std::string("<>!").find(text[i - 1]) != std::string::npos;
        if (!doubled && !compound)
            throw expressionError(where, text, i, "'=' assigns; expected a comparison '=='");
        i += doubled ? 1 : 0;
    }
}

double clampValue(double value, double low, double high) { return std::min(std::max(value, low), high); }

double smoothStep(double low, double high, double value) {
    const double t = clampValue((value - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

void defineNames(mu::Parser& parser) {
    parser.DefineConst("pi", std::numbers::pi);
    parser.DefineFun("pow", +[](double base, double exponent) { return std::pow(base, exponent); });
    parser.DefineFun("erf", +[](double value) { return std::erf(value); });
    parser.DefineFun("erfc", +[](double value) { return std::erfc(value); });
    parser.DefineFun("floor", +[](double value) { return std::floor(value); });
    parser.DefineFun("ceil", +[](double value) { return std::ceil(value); });
    parser.DefineFun("mod", +[](double value, double period) { return value - period * std::floor(value / period); });
    parser.DefineFun("clamp", clampValue);
    parser.DefineFun("smoothstep", smoothStep);
    parser.DefineFun("hypot", +[](double a, double b) { return std::hypot(a, b); });
}

} // namespace

Expression::Expression(const std::string& text, const SourcePosition& where) : state_(std::make_unique<State>()) {
    rejectAssignment(text, where);
    state_->text = text;
    try {
        mu::Parser& parser = state_->parser;
        defineNames(parser);
        parser.DefineVar("x", &state_->x);
        parser.DefineVar("y", &state_->y);
        parser.DefineVar("z", &state_->z);
        parser.DefineVar("r", &state_->r);
        parser.SetExpr(text);
        int values = 0;
        parser.Eval(values);
        if (values != 1)
            throw expressionError(where, text, 0, fmt::format("expected one value, found {}", values));
    } catch (const mu::ParserError& error) {  // no std::exception
        const std::size_t offset = error.GetPos() < 0 ? 0 : std::size_t(error.GetPos());
        throw expressionError(where, text, std::min(offset, text.size()), error.GetMsg());
    }
}

Expression::~Expression() = default;
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;

const std::string& Expression::text() const { return state_->text; }

double Expression::operator()(const glm::dvec3& point) const {
    state_->x = point.x;
    state_->y = point.y;
    state_->z = point.z;
    state_->r = glm::length(point);
    try {
        return state_->parser.Eval();
    } catch (const mu::ParserError&) {
        return std::numeric_limits<double>::quiet_NaN();
    }
}

std::string expressionFunctions() {
    return "variables x, y, z, r; constants pi, _e; + - * / ^ < <= > >= == != && || ?:; sqrt exp log ln log2 log10 abs "
           "sign min max sum avg sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh rint pow erf erfc "
           "floor ceil mod clamp smoothstep hypot";
}

} // namespace eikonal
