#ifndef caudal_base_expression_h
#define caudal_base_expression_h

#include <deal.II/base/function_parser.h>

#include <memory>
#include <string>

namespace caudal
{
  /**
   * The function that the .prm gives as text: of the coordinates x, y (z) and
   * the time t, its components separated by ';'. @p path is the entry that
   * error messages name. Throws if the text is not a function of
   * @p n_components components.
   */
  template <int dim>
  std::unique_ptr<dealii::FunctionParser<dim>> make_expression(const std::string &path,
                                                               const std::string &expression,
                                                               unsigned int       n_components);

  /** Throws unless the function is finite at @p point: to be called where it is evaluated. */
  template <int dim>
  void check_finite(const std::string &path, const std::string &expression,
                    const dealii::Function<dim> &function, const dealii::Point<dim> &point);
} // namespace caudal

#endif
