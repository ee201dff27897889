// SPDX-License-Identifier: MIT
#include "render/drawing/plots/method_look.h"

namespace polhode {

PlotLook look_of(Method method) {
  switch (method) {
    case Method::exact:
    case Method::uniform:
    case Method::symmetric:
    case Method::lagrange_top:
      return PlotLook::star;
    case Method::explicit_euler:
    case Method::explicit_midpoint:
    case Method::rk4:
    case Method::rk4_projected:
      return PlotLook::orange;
    case Method::dormand_prince_5:
    case Method::dormand_prince_8:
      return PlotLook::purple;
    case Method::splitting:
    case Method::implicit_midpoint:
    case Method::implicit_midpoint_exp:
    case Method::moser_veselov_2:
    case Method::moser_veselov_6:
    case Method::moser_veselov_10:
      return PlotLook::blue;
  }
  return PlotLook::grey;
}

PlaceInLook place_of(Method method) {
  const PlotLook look = look_of(method);
  PlaceInLook found{.place = 0, .members = 0};
  for (const MethodFacts& facts : all_methods()) {
    if (look_of(facts.method) != look) continue;
    if (facts.method == method) found.place = found.members;
    ++found.members;
  }
  return found;
}

}  // namespace polhode
