// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/json.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace caudal
{
  namespace
  {
    std::string quote(const std::string &text)
    {
      std::string result = "\"";
      for (const char c : text)
        result += c == '"' || c == '\\'                  ? std::string("\\") + c
                  : static_cast<unsigned char>(c) < 0x20 ? std::string(" ")
                                                         : std::string(1, c);
      return result + '"';
    }
  } // namespace

  Json::Json(const bool value)
      : text(value ? "true" : "false")
  {}

  Json::Json(const int value)
      : text(std::to_string(value))
  {}

  Json::Json(const std::size_t value)
      : text(std::to_string(value))
  {}

  Json::Json(const double value)
  {
    if (!std::isfinite(value))
      return;
    std::ostringstream digits;
    digits << std::setprecision(10) << value;
    text = digits.str();
  }

  Json::Json(const std::string &value)
      : text(quote(value))
  {}

  Json::Json(const char *const value)
      : text(quote(value))
  {}

  Json Json::object()
  {
    Json result;
    result.kind = Kind::object;
    return result;
  }

  Json Json::array()
  {
    Json result;
    result.kind = Kind::array;
    return result;
  }

  Json &Json::add(const std::string &name, Json value)
  {
    Assert(kind == Kind::object, dealii::ExcInternalError());
    members.emplace_back(name, std::move(value));
    return *this;
  }

  Json &Json::append(Json value)
  {
    Assert(kind == Kind::array, dealii::ExcInternalError());
    members.emplace_back("", std::move(value));
    return *this;
  }

  void Json::write(std::ostream &out, const std::string &indentation) const
  {
    if (kind == Kind::scalar)
    {
      out << text;
      return;
    }
    const bool        is_flat = std::all_of(members.begin(), members.end(), [](const auto &member) {
      return member.second.kind == Kind::scalar;
    });
    const std::string inner   = indentation + "  ";
    std::string       separator = is_flat ? "" : "\n" + inner;
    out << (kind == Kind::object ? '{' : '[');
    for (const auto &[name, value] : members)
    {
      out << separator;
      if (kind == Kind::object)
        out << quote(name) << ": ";
      value.write(out, inner);
      separator = is_flat ? ", " : ",\n" + inner;
    }
    out << (is_flat ? "" : "\n" + indentation) << (kind == Kind::object ? '}' : ']');
  }
} // namespace caudal
