// Quotient and remainder of whole numbers below 2^24, by way of a quotient of floats that is right to one: the software renderer
// divides whole numbers one lane after the other.
uvec2 divided(uint dividend, uint divisor) {
    uint quotient = uint(float(dividend) / float(divisor));
    int remainder = int(dividend - quotient * divisor);
    int off = remainder < 0 ? -1 : remainder >= int(divisor) ? 1 : 0;
    return uvec2(int(quotient) + off, remainder - off * int(divisor));
}
