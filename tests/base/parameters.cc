// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameter files: includes, overrides and what is said of mistakes in them;
// the reference of all parameters; the command line.

#include <caudal/base/command_line.h>
#include <caudal/base/declared_parameters.h>
#include <caudal/base/parameter_file.h>

#include <fstream>
#include <iostream>

using namespace caudal;

namespace
{
  struct Parameters
  {
    double                   length = 1;
    unsigned int             points = 12;
    std::string              kernel = "four-point";
    bool                     moving = true;
    std::vector<double>      corner = {0, 0};
    std::vector<std::string> bodies = {"fish"};

    void add_parameters(ParameterHandler &prm)
    {
      prm.add_parameter("Bodies", bodies, "Names of the bodies.");
      prm.enter_subsection("Body fish");
      {
        prm.add_parameter("Moving", moving, "Whether it moves.");
        prm.enter_subsection("Shape");
        prm.add_parameter("Length", length, "Length [m].", Patterns::Double(0));
        prm.add_parameter("Points", points, "Points of the outline.", Patterns::Integer(1, 999));
        prm.leave_subsection();
      }
      prm.leave_subsection();
      prm.enter_subsection("Coupling");
      prm.add_parameter("Kernel", kernel, "The delta kernel | by name.",
                        Patterns::Selection("four-point|hat|dirac"));
      prm.add_parameter("Corner", corner, "A point [m].", Patterns::List(Patterns::Double(), 2, 2));
      prm.declare_entry("Title", "", Patterns::Anything(), "A required text.", true);
      prm.leave_subsection();
    }
  };

  void write(const std::string &file, const std::string &text)
  {
    std::ofstream(file) << text;
  }

  /** Prints the sentences that an exception carries. */
  template <class Function>
  void try_to(const Function &function)
  {
    try
    {
      function();
      std::cout << "    no error\n";
    }
    catch (const ExceptionBase &exception)
    {
      exception.print_info(std::cout);
    }
  }

  void parse(const std::string &file, const std::vector<std::string> &overrides = {})
  {
    ParameterHandler prm;
    Parameters       p;
    p.add_parameters(prm);
    const ParameterFile input(file, overrides);
    std::cout << "Bodies: " << input.get("Bodies", "none")
              << ", length: " << input.get("Body fish/Shape/Length", "default") << '\n';
    input.parse(prm);
    std::cout << p.length << ' ' << p.points << ' ' << p.kernel << ' ' << p.moving << ' '
              << p.corner[1] << ' ' << p.bodies.size() << '\n';
  }

  void test_good_files()
  {
    write("base.prm", "set Bodies = fish, \\\n   cylinder # two\n"
                      "subsection Body fish\n  subsection Shape\n    set Length = 3\n  end\nend\n");
    write("good.prm", "include base.prm\n# a comment\nsubsection Coupling\n  set Title = x\n"
                      "  set   Kernel=  hat\r\n  set Corner = 1, 2.5\nend\n"
                      "subsection Body fish\n  include shape.prm\nend\n");
    write("shape.prm", "subsection Shape\n  set Length = 4\n  set Points = 7\nend\n");
    parse("good.prm");
    parse("./good.prm", {"Body fish/Shape/Length=5", "Body fish / Moving = false"});
  }

  void test_bad_files()
  {
    const std::string title = "subsection Coupling\n  set Title = x\nend\n";
    write("unknown.prm",
          "subsection Coupling\n  set Kernal = hat\n  set Title = x\n  set Kernel = cone\n"
          "  set Corner = 1\nend\nsubsection Body fisch\n  set Moving = false\n"
          "  subsection Shape\n  end\nend\nset Height = 2\n");
    write("outer.prm", "\n" + title + "include unknown.prm\n");
    try_to([] { parse("outer.prm"); });

    write("range.prm", title + "subsection Body fish\n  set Moving = perhaps\n  subsection Shape\n"
                               "    set Length = -1\n    set Points = 2.5\n  end\nend\n");
    try_to([] { parse("range.prm", {"Body fish/Shape/Points=0"}); });

    write("required.prm", "set Bodies = fish\n");
    try_to([] { parse("required.prm"); });

    write("end.prm", "subsection Coupling\nend\nend\n");
    try_to([] { parse("end.prm"); });
    write("open.prm", "subsection Body fish\n  subsection Shape\n  end\n\n");
    try_to([] { parse("open.prm"); });
    write("nonsense.prm", "Kernel = hat\n");
    try_to([] { parse("nonsense.prm"); });
    write("no_value.prm", "subsection Coupling\n  set Kernel\nend\n");
    try_to([] { parse("no_value.prm"); });
    write("missing.prm", "\ninclude nothing.prm\n");
    try_to([] { parse("missing.prm"); });
    write("circle.prm", "include back.prm\n");
    write("back.prm", "include circle.prm\n");
    try_to([] { parse("circle.prm"); });
    try_to([] { parse("absent.prm"); });
    try_to([] { parse("."); });

    try_to([] { parse("good.prm", {"Coupling/Kernal=hat"}); });
    try_to([] { parse("good.prm", {"Couplings/Kernel=hat"}); });
    try_to([] { parse("good.prm", {"Coupling/Kernel=cone"}); });
    try_to([] { parse("good.prm", {"Coupling/Kernel"}); });
    try_to([] { parse("good.prm", {"Coupling//Kernel=hat"}); });
  }

  /** Names of an earlier version: entries, a section, a value, and others in a section that stays.
   */
  void rename(const std::string &file, const std::vector<std::string> &overrides = {})
  {
    ParameterHandler prm;
    Parameters       p;
    p.add_parameters(prm);
    ParameterFile input(file, overrides);
    input.rename({{"Form/Size", "Body fish/Shape/Length"},
                  {"Swimmer */Form", "Body */Shape"},
                  {"Swimmer *", "Body *"},
                  {"Delta", "Coupling/Kernel", "cone", "hat"},
                  {"Delta", "Coupling/Kernel"}});
    for (const std::string &hint : input.get_hints())
      std::cout << hint << '\n';
    input.parse(prm);
    std::cout << p.length << ' ' << p.points << ' ' << p.kernel << ' ' << p.moving << '\n';
  }

  void test_renamed_entries()
  {
    write("title.prm", "subsection Coupling\n  set Title = x\nend\n");
    write("former.prm", "include title.prm\nset Delta = cone\n"
                        "subsection Swimmer fish\n  set Moving = false\n  subsection Form\n"
                        "    set Points = 3\n  end\nend\n"
                        "subsection Form\n  set Size = 5\nend\n");
    rename("former.prm");
    rename("former.prm", {"Swimmer fish/Form/Length=6", "Delta=dirac"});
    rename("former.prm", {"Body fish/Shape/Length=6", "Coupling/Kernel=dirac"});
    write("both.prm", "include former.prm\nsubsection Body fish\n  subsection Shape\n"
                      "    set Length = 1\n  end\nend\n");
    try_to([] { rename("both.prm"); });
    write("lost.prm", "include title.prm\nsubsection Form\n  set Size = 5\n  set Shade = 1\n"
                      "  subsection Nose\n    set Length = 1\n  end\nend\n"
                      "subsection Swimmer fish\n  set Shade = 1\nend\n");
    try_to([] { rename("lost.prm"); });
    write("present.prm", "include title.prm\nsubsection Body fish\n  set Moving = false\nend\n");
    rename("present.prm");
  }

  void test_command_line(std::vector<const char *> arguments)
  {
    arguments.insert(arguments.begin(), "caudal");
    try_to([&] {
      const CommandLine line = parse_command_line(arguments.size(), arguments.data());
      std::cout << static_cast<int>(line.action) << " <" << line.file << "> " << line.format
                << (line.fast ? " fast" : "");
      for (const std::string &text : line.overrides)
        std::cout << " <" << text << '>';
      std::cout << '\n';
    });
  }
} // namespace

int main()
{
  test_good_files();
  test_bad_files();
  test_renamed_entries();

  ParameterHandler prm;
  Parameters       p;
  p.add_parameters(prm);
  print_parameters(std::cout, prm, "md");
  print_parameters(std::cout, prm, "prm");

  test_command_line({"a.prm", "-D", "A/B=1", "-DC=2"});
  test_command_line({"--check", "a.prm"});
  test_command_line({"--check", "--fast", "a.prm"});
  test_command_line({"--fast", "a.prm"});
  test_command_line({"--help"});
  test_command_line({"--version"});
  test_command_line({"--print-parameters", "md", "a.prm"});
  test_command_line({"--print-parameters"});
  test_command_line({});
  test_command_line({"--check"});
  test_command_line({"--chek", "a.prm"});
  test_command_line({"a.prm", "b.prm"});
  test_command_line({"a.prm", "-D"});
  test_command_line({"--help", "--check"});
}
