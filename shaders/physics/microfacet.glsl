// Rough surfaces of dielectrics: facets with the distribution of Trowbridge and Reitz (GGX), of which light meets one. B. Walter
// et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007; the facets that a direction sees: E. Heitz,
// "Sampling the GGX Distribution of Visible Normals", JCGT 7(4), 2018.

const real kWholeTurn = 6.28318530717958647693;

// Smith's share of the facets, of those turned towards a direction, that no others hide from it. cosine: of the direction to
// the surface's normal.
real facetVisibility(real cosine, real alpha) {
    real tangentSquare = 1.0 / max(cosine * cosine, 1.0e-12) - 1.0;
    return 2.0 / (1.0 + sqrt(1.0 + alpha * alpha * max(tangentSquare, 0.0)));
}

// Normal of a facet, each as likely as it is large to a direction `towards` above the surface. The surface's normal is +z; u, v:
// uniform from 0 to 1.
real3 visibleFacet(real3 towards, real alpha, real u, real v) {
    real3 stretched = normalize(real3(alpha * towards.x, alpha * towards.y, towards.z));
    real across = sqrt(stretched.x * stretched.x + stretched.y * stretched.y);
    real3 first = real3(1.0, 0.0, 0.0);
    if (across > 0.0) {
        first = real3(-stretched.y, stretched.x, 0.0) / across;
    }
    real3 second = cross(stretched, first);
    real a = sqrt(u) * cos(kWholeTurn * v);
    real upper = 0.5 * (1.0 + stretched.z);
    real b = (1.0 - upper) * sqrt(max(1.0 - a * a, 0.0)) + upper * sqrt(u) * sin(kWholeTurn * v);
    real3 facet = first * a + second * b + stretched * sqrt(max(1.0 - a * a - b * b, 0.0));
    return normalize(real3(alpha * facet.x, alpha * facet.y, max(facet.z, 0.0)));
}

// Probability density of visibleFacet() at a facet, per steradian.
real visibleFacetDensity(real3 towards, real3 facet, real alpha) {
    real squash = facet.z * facet.z * (alpha * alpha - 1.0) + 1.0;
    real distribution = 2.0 * alpha * alpha / (kWholeTurn * squash * squash);
    return distribution * facetVisibility(towards.z, alpha) * dot(towards, facet) / towards.z;
}

// What goes on of light that one facet lets through, with this transmittance: all that no others hide; the rest meets another and
// is let through by that as well. Where both sides have the same index there is no surface, and nothing is lost.
real throughFacets(real seen, real transmittance) {
    return transmittance * (seen + (1.0 - seen) * transmittance);
}

// Wave vector behind a plane, by Snell's law; normal: unit, against `before`. Beyond the critical angle it is along the plane.
real3 refractedWave(real3 before, real3 normal, real n2) {
    real3 tangential = before - normal * dot(before, normal);
    return tangential - normal * sqrt(max(n2 * n2 - dot(tangential, tangential), 0.0));
}

// What becomes of light at one of the facets that it sees, a `share` of all that are looked at. What other facets take away of the
// light that is reflected is lost.
// before: wave vector of the ray that meets the surface from index n1; normal: unit, against it. Index beyond: n2.
BoundarySplit splitAtFacet(real3 before, real3 normal, real n1, real n2, real alpha, real u, real v, real share) {
    real3 axis = real3(1.0, 0.0, 0.0);
    if (abs(normal.x) > 0.5) {
        axis = real3(0.0, 1.0, 0.0);
    }
    real3 first = normalize(cross(axis, normal));
    real3 second = cross(normal, first);
    real3 towards = real3(-dot(before, first), -dot(before, second), -dot(before, normal)) / n1;
    real3 local = visibleFacet(towards, alpha, u, v);
    real3 facet = first * local.x + second * local.y + normal * local.z;

    BoundarySplit result;
    real along = dot(before, facet);
    real3 tangential = before - facet * along;
    Polarised reflectance = fresnelReflectance(n1, n2, length(tangential));
    real turned = 2.0 * along;
    result.away = before - facet * turned;
    result.onward = refractedWave(before, facet, n2);
    real up = dot(result.away, normal) / n1;
    real down = -dot(result.onward, normal) / n2;
    real awayShare = up > 0.0 ? facetVisibility(up, alpha) : 0.0;
    real seen = facetVisibility(down, alpha);
    result.reflected.s = awayShare * reflectance.s;
    result.reflected.p = awayShare * reflectance.p;
    result.transmitted.s = down > 0.0 ? throughFacets(seen, 1.0 - reflectance.s) : 0.0;
    result.transmitted.p = down > 0.0 ? throughFacets(seen, 1.0 - reflectance.p) : 0.0;
    // Walter et al., eqs. 14 and 17: directions for a steradian of facets
    real facets = share / visibleFacetDensity(towards, local, alpha);
    real cosine = -along / n1;
    real onwardCosine = max(-dot(result.onward, facet) / n2, 1.0e-6);
    real across = n1 * cosine - n2 * onwardCosine;
    result.awaySpread = facets * 4.0 * cosine;
    result.onwardSpread = facets * across * across / (n2 * n2 * onwardCosine);
    return result;
}

// GGX's alpha of the roughness that scenes give.
real alphaOfRoughness(real roughness) {
    return roughness * roughness;
}
