// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_json_h
#define caudal_base_json_h

#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace caudal
{
  /**
   * A value of JSON (RFC 8259): null, truth value, number, text, object or array. Boost's
   * property tree writes all of them as texts, and Boost.JSON is younger than Debian 12's Boost.
   */
  class Json
  {
  public:
    Json() = default;
    Json(bool value);
    Json(int value);
    Json(std::size_t value);
    /** Ten digits; what is not finite is null. */
    Json(double value);
    Json(const std::string &value);
    Json(const char *value);

    static Json object();
    static Json array();

    /** Adds a member to an object; returns the object. */
    Json &add(const std::string &name, Json value);

    /** Adds an element to an array; returns the array. */
    Json &append(Json value);

    /** Objects and arrays of scalars stand on one line, others have a line for each member. */
    void write(std::ostream &out, const std::string &indentation = "") const;

  private:
    enum class Kind
    {
      scalar,
      object,
      array
    };

    Kind                                      kind = Kind::scalar;
    std::string                               text = "null"; // of a scalar
    std::vector<std::pair<std::string, Json>> members;       // without names in an array
  };
} // namespace caudal

#endif
