// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_expression_h
#define caudal_base_expression_h

#include <deal.II/base/function_parser.h>

#include <string>

namespace caudal
{
  using namespace dealii;

  /**
   * A function that the .prm gives as text. Its values are finite: where it is not defined,
   * evaluation throws a sentence with the entry, the text and the place.
   */
  template <int dim>
  class Expression : public Function<dim>
  {
  public:
    /**
     * A function of the coordinates x, y (z) and the time t, its @p n_components components
     * separated by ';'. @p path is the entry that errors name. Throws if the text is none.
     */
    Expression(const std::string &path, const std::string &text, unsigned int n_components);

    /** A function of dim other @p variables, separated by ',': "s,y". */
    Expression(const std::string &path, const std::string &variables, const std::string &text);

    /** A copy, which parses the text once more. */
    Expression(const Expression &other);

    double value(const Point<dim> &point, unsigned int component = 0) const override;
    void   vector_value(const Point<dim> &point, Vector<double> &values) const override;
    void   set_time(double time) override;

  private:
    const std::string   path, variables, text;
    const bool          is_in_space;
    FunctionParser<dim> function;

    void        parse();
    void        check(double value, const Point<dim> &point) const;
    std::string describe_place(const Point<dim> &point) const;
  };
} // namespace caudal

#endif
