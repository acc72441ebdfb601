// Tangled from paper/18-what-heat-can-do.md; edit there.
#include "studies/materials.hpp"

#include "thermoroll/scene.hpp"

namespace thermoroll {

double shear_modulus(const Material& m) { return m.youngs_modulus / (2 * (1 + m.poisson)); }

double grueneisen(const Material& m) {
  return grueneisen(m.density * m.heat_capacity, m.expansion, shear_modulus(m), m.poisson);
}

double heating_of_size(const Material& m, double half_width_over_radius) {
  const double nu = m.poisson;
  return pi / 4 * (1 - 2 * nu) / (1 - nu) * grueneisen(m) * half_width_over_radius;
}

const std::vector<Material>& materials() {
  static const std::vector<Material> list{{"mild steel", 212e9, 0.293, 12.0e-6, 7850, 486},
                                          {"aluminium", 70.3e9, 0.345, 23.6e-6, 2702, 900},
                                          {"copper", 130e9, 0.343, 17.0e-6, 8933, 386},
                                          {"cartridge brass", 101e9, 0.350, 20.0e-6, 8530, 375},
                                          {"titanium", 120e9, 0.361, 8.6e-6, 4500, 522},
                                          {"tungsten", 411e9, 0.280, 4.5e-6, 19300, 138},
                                          {"alumina", 400e9, 0.22, 7.6e-6, 3970, 775},
                                          {"silicon carbide", 396e9, 0.22, 4.6e-6, 3160, 670},
                                          {"soda–lime glass", 69e9, 0.20, 9.0e-6, 2500, 840},
                                          {"nylon 66", 2.7e9, 0.41, 144e-6, 1140, 1670}};
  return list;
}

}  // namespace thermoroll
