// SPDX-License-Identifier: LGPL-2.1-or-later
// Q and lambda_2 of flows whose gradients are known: a rotation, a shear flow, a strain, Burgers'
// vortex in its middle, and the last one seen in another frame. In plane flow lambda_2 is -Q.

#include <caudal/observe/flow_quantity.h>

#include <deal.II/physics/transformations.h>

#include <iomanip>
#include <iostream>

using namespace caudal;

namespace
{
  template <int dim>
  void print(const std::string &flow, const Tensor<2, dim> &gradient)
  {
    std::cout << dim << "D, " << flow << ":";
    for (const auto &[name, quantity] : PluginList<FlowQuantity<dim>>())
      std::cout << "  " << name << " = " << quantity->evaluate(gradient);
    std::cout << '\n';
  }

  template <int dim>
  void print_plane_flows()
  {
    Tensor<2, dim> rotation, shear, strain;
    rotation[0][1] = -1.5;
    rotation[1][0] = 1.5;
    shear[0][1]    = 2;
    strain[0][0]   = 0.5;
    strain[1][1]   = -0.5;
    print("rotation at 1.5/s", rotation);
    print("shear flow of 2/s", shear);
    print("strain of 0.5/s", strain);
    print("rotation and strain", rotation + strain);
  }
} // namespace

int main()
{
  load_libraries(""); // none beside the program's own
  std::cout << std::fixed << std::setprecision(6);
  print_plane_flows<2>();
  print_plane_flows<3>();

  // Q = w^2 - 3/4 a^2 and lambda_2 = a^2/4 - w^2.
  const double a = 2, w = 1.5;
  Tensor<2, 3> burgers;
  burgers[0][0] = burgers[1][1] = -a / 2;
  burgers[2][2]                 = a;
  burgers[0][1]                 = -w;
  burgers[1][0]                 = w;
  print("Burgers' vortex", burgers);
  const Tensor<2, 3> turn =
      Physics::Transformations::Rotations::rotation_matrix_3d(Tensor<1, 3>({0.6, 0, 0.8}), 1.);
  print("the same, turned", turn * burgers * transpose(turn));
}
