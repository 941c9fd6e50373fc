// The shading language's functions of real numbers for shaders/physics as C++. Included inside the namespace that defines
// `real`, once for each precision, hence no include guard. No templates, so that literals of the other precision convert;
// dot, length and normalize of vectors come from GLM by argument-dependent lookup.

inline real min(real a, real b) { return a < b ? a : b; }
inline real max(real a, real b) { return a < b ? b : a; }
inline real clamp(real x, real low, real high) { return min(max(x, low), high); }
inline real abs(real x) { return std::abs(x); }
inline real sqrt(real x) { return std::sqrt(x); }
inline real exp(real x) { return std::exp(x); }
inline real log2(real x) { return std::log2(x); }
inline real pow(real x, real y) { return std::pow(x, y); }
inline real sin(real x) { return std::sin(x); }
inline real cos(real x) { return std::cos(x); }
inline real atan(real y, real x) { return std::atan2(y, x); }
