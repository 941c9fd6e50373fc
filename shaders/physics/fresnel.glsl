// Reflectance of an interface between two indices, by polarisation (docs/physics.md, section 4).
// R_s = ((n1 c1 - n2 c2)/(n1 c1 + n2 c2))^2, R_p = ((n2 c1 - n1 c2)/(n2 c1 + n1 c2))^2, c = cos of the ray to the normal.

struct Polarised {
    real s;  // perpendicular to the plane of incidence
    real p;  // in the plane of incidence
};

// wTangential: the component of the wave vector along the interface, n sin(theta), equal on both sides (Snell).
// Beyond the critical angle both are 1.
Polarised fresnelReflectance(real n1, real n2, real wTangential) {
    Polarised reflectance;
    real k1 = sqrt(max(n1 * n1 - wTangential * wTangential, 0.0));  // n1 cos(theta1)
    real k2 = sqrt(max(n2 * n2 - wTangential * wTangential, 0.0));  // n2 cos(theta2)
    real sumS = k1 + k2;
    real sumP = n2 * n2 * k1 + n1 * n1 * k2;
    if (sumS <= 0.0 || sumP <= 0.0) {
        reflectance.s = 1.0;
        reflectance.p = 1.0;
        return reflectance;
    }
    real s = (k1 - k2) / sumS;
    real p = (n2 * n2 * k1 - n1 * n1 * k2) / sumP;
    reflectance.s = s * s;
    reflectance.p = p * p;
    return reflectance;
}
