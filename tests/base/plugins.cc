// SPDX-License-Identifier: LGPL-2.1-or-later
// Plug-ins: members that register themselves, own their parameters and are
// chosen by name; what is set for those that are not chosen; libraries.

#include <caudal/base/collective.h>
#include <caudal/base/parameter_file.h>
#include <caudal/base/plugin.h>

#include <fstream>
#include <iostream>

using namespace caudal;

namespace
{
  class Shape : public Plugin
  {
  public:
    virtual double area() const = 0;
  };

  class Square : public Shape
  {
  public:
    void add_parameters(ParameterHandler &prm) override
    {
      prm.add_parameter("Edge", edge, "Edge [m].");
    }
    void check(const std::string &path) const override
    {
      AssertThrow(edge > 0, ExcMessage(path + "/Edge: it is not positive."));
    }
    double area() const override
    {
      return edge * edge;
    }

  private:
    double edge = 2;
  };

  class Circle : public Square
  {
  public:
    double area() const override
    {
      return numbers::PI / 4 * Square::area();
    }
  };

  class Nothing : public Shape
  {
  public:
    double area() const override
    {
      return 0;
    }
  };

  const Registration<Shape, Square>  square("square", "all edges are equal");
  const Registration<Shape, Circle>  circle("round disc", "a square without corners");
  const Registration<Shape, Nothing> nothing("none", "no area");

  /** Prints the area of the shape that a file with these lines chooses. */
  void run(const std::string &lines)
  {
    std::ofstream("plugins.prm") << "subsection Body\n" << lines << "end\n";
    const std::string error = catch_error([&] {
      ParameterHandler prm;
      Choice<Shape>    shape("Type", "square", "The shape:");
      Choice<Shape>    left("left", "none", "The shape on the left:", "left ");
      prm.enter_subsection("Body");
      shape.add_parameters(prm);
      left.add_parameters(prm);
      prm.leave_subsection();
      const ParameterFile file("plugins.prm");
      file.parse(prm);
      shape.check("Body");
      left.check("Body");
      for (const std::string &sentence : file.find_idle_entries(prm))
        std::cout << sentence << '\n';
      const std::unique_ptr<Shape> copy = shape.create();
      std::cout << shape.get_name() << ' ' << copy->area() << ", left " << left.get().area()
                << '\n';
    });
    std::cout << error << (error.empty() ? "" : "\n");
  }
} // namespace

int main()
{
  run("");
  run("set Type = round disc\nsubsection Round disc\n  set Edge = 3\nend\n");
  run("set Type = round disc\nsubsection Square\n  set Edge = 3\nend\n");
  run("set left = square\nsubsection Left square\n  set Edge = 3\nend\n"
      "subsection Left round disc\n  set Edge = 1\nend\n");
  run("subsection Round disc\n  set Edge = 2\nend\n");
  std::ofstream("square.prm") << "set Type = square\nsubsection Square\n  set Edge = 3\nend\n";
  run("include square.prm\nset Type = none\n");
  run("include square.prm\nset Type = none\nsubsection Square\n  set Edge = 4\nend\n");
  run("set Type = triangle\n");
  run("subsection Square\n  set Edge = -3\nend\n");
  run("subsection None\nend\n");

  ParameterHandler prm;
  Choice<Shape>    shape("Type", "square", "The shape:");
  shape.add_parameters(prm);
  prm.print_parameters(std::cout, ParameterHandler::PRM);

  std::cout << catch_error([] { load_libraries(""); });
  std::cout << catch_error([] { load_libraries("libnothing.so"); }) << '\n';
  std::ofstream("libtext.so") << "no library\n";
  const std::string error = catch_error([] { load_libraries("libtext.so"); });
  std::cout << error.substr(0, error.find('(')) << '\n';

  const Registration<Shape, Circle> second("square", "another one of this name");
  std::cout << catch_error([] { load_libraries(""); }) << '\n';
}
