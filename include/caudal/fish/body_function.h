#ifndef caudal_fish_body_function_h
#define caudal_fish_body_function_h

#include <deal.II/base/function_parser.h>

#include <string>

namespace caudal
{
  using namespace dealii;

  /**
   * A function of two variables that the .prm gives as text, such as a
   * distribution along the body, g(s,y).
   */
  class BodyFunction
  {
  public:
    /** @p variables are two names separated by ','; @p path is the entry that errors name. */
    BodyFunction(const std::string &path, const std::string &variables,
                 const std::string &expression);

    /** Throws if the value is not finite. */
    double value(const double first, const double second) const;

    /** Throws unless it is finite at some places along the body. */
    void check_along() const;

  private:
    const std::string path;
    const std::string variables;
    const std::string expression;
    FunctionParser<2> function;
  };
} // namespace caudal

#endif
