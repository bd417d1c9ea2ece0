// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/mesh/gmsh_binary.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <cstring>
#include <limits>
#include <map>
#include <sstream>

namespace caudal
{
  using namespace dealii;

  namespace
  {
    /** The number of nodes of gmsh's elements, by their type. */
    const std::map<int, unsigned int> n_nodes_of_types = {
        {1, 2},  {2, 3},  {3, 4},   {4, 4},   {5, 8},   {6, 6},   {7, 5},
        {8, 3},  {9, 6},  {10, 9},  {11, 10}, {12, 27}, {13, 18}, {14, 14},
        {15, 1}, {16, 8}, {17, 20}, {18, 15}, {19, 13}};

    unsigned int get_n_nodes(const int type)
    {
      const auto found = n_nodes_of_types.find(type);
      AssertThrow(found != n_nodes_of_types.end(),
                  ExcMessage("the element type " + std::to_string(type) + " is not known."));
      return found->second;
    }

    /** Turns a binary mesh into text, number by number. */
    class Converter
    {
    public:
      explicit Converter(const std::string &contents)
          : contents(contents)
      {
        text.precision(std::numeric_limits<double>::max_digits10);
      }

      std::string convert()
      {
        while (position < contents.size())
          convert_section(Utilities::trim(get_line()));
        return text.str();
      }

    private:
      const std::string &contents;
      std::size_t        position = 0;
      double             version  = 0;
      std::ostringstream text;

      std::string get_line()
      {
        const std::size_t end  = std::min(contents.find('\n', position), contents.size() - 1);
        const std::string line = contents.substr(position, end - position);
        position               = end + 1;
        return line;
      }

      /** Copies @p n numbers, and returns the last of them. */
      template <typename Number>
      Number copy(const std::size_t n = 1)
      {
        AssertThrow(n <= (contents.size() - position) / sizeof(Number),
                    ExcMessage("it ends too early."));
        Number number = 0;
        for (std::size_t i = 0; i < n; ++i, position += sizeof(Number))
        {
          std::memcpy(&number, &contents[position], sizeof(Number));
          text << number << ' ';
        }
        return number;
      }

      void convert_section(const std::string &header)
      {
        if (header.empty())
          return;
        AssertThrow(header[0] == '$', ExcMessage("there is no section where one should begin."));
        const std::string end     = "$End" + header.substr(1);
        bool              is_read = true;
        if (header == "$MeshFormat")
          convert_format();
        else if (header == "$Entities" || header == "$Nodes" || header == "$Elements")
        {
          text << header << '\n';
          if (header == "$Entities")
            convert_entities();
          else if (header == "$Nodes")
            version < 4 ? convert_nodes_of_format_2() : convert_nodes();
          else
            version < 4 ? convert_elements_of_format_2() : convert_elements();
          text << end << '\n';
        }
        else
          is_read = false;
        const std::size_t found = contents.find(end, position);
        AssertThrow(found != std::string::npos,
                    ExcMessage("the section " + header + " has no end."));
        const std::string rest = contents.substr(position, found - position);
        AssertThrow(!is_read || Utilities::trim(rest).empty(),
                    ExcMessage("the section " + header + " holds more than it says."));
        if (header == "$PhysicalNames")
          text << header << '\n' << rest << end << '\n';
        position = found;
        get_line();
      }

      void convert_format()
      {
        std::istringstream line(get_line());
        int                is_binary = 0, size = 0, one = 0;
        line >> version >> is_binary >> size;
        AssertThrow((version == 2.2 || version == 4.1) && size == 8,
                    ExcMessage("it is a binary file of a format other than 2.2 and 4.1."));
        const std::size_t length = std::min(sizeof(one), contents.size() - position);
        std::memcpy(&one, &contents[position], length);
        position += length;
        AssertThrow(one == 1, ExcMessage("it is a binary file of another kind of machine."));
        text << "$MeshFormat\n" << version << " 0 8\n$EndMeshFormat\n";
      }

      /** Points have a place, other entities a box and those that bound them. */
      void convert_entities()
      {
        std::size_t n_entities[4];
        for (std::size_t &n : n_entities)
          n = copy<std::size_t>();
        text << '\n';
        for (unsigned int d = 0; d < 4; ++d)
          for (std::size_t e = 0; e < n_entities[d]; ++e, text << '\n')
          {
            copy<int>();
            copy<double>(d == 0 ? 3 : 6);
            copy<int>(copy<std::size_t>());
            if (d > 0)
              copy<int>(copy<std::size_t>());
          }
      }

      /** Numbers of blocks and nodes, smallest and largest tag; blocks of tags and places. */
      void convert_nodes()
      {
        const std::size_t n_blocks = copy<std::size_t>();
        copy<std::size_t>(3);
        text << '\n';
        for (std::size_t b = 0; b < n_blocks; ++b)
        {
          copy<int>(2);
          AssertThrow(copy<int>() == 0, ExcMessage("its nodes have parametric coordinates."));
          const std::size_t n_nodes = copy<std::size_t>();
          text << '\n';
          for (std::size_t i = 0; i < n_nodes; ++i, text << '\n')
            copy<std::size_t>();
          for (std::size_t i = 0; i < n_nodes; ++i, text << '\n')
            copy<double>(3);
        }
      }

      void convert_elements()
      {
        const std::size_t n_blocks = copy<std::size_t>();
        copy<std::size_t>(3);
        text << '\n';
        for (std::size_t b = 0; b < n_blocks; ++b)
        {
          copy<int>(2);
          const unsigned int n_nodes    = get_n_nodes(copy<int>());
          const std::size_t  n_elements = copy<std::size_t>();
          text << '\n';
          for (std::size_t e = 0; e < n_elements; ++e, text << '\n')
            copy<std::size_t>(1 + n_nodes);
        }
      }

      void convert_nodes_of_format_2()
      {
        const int n_nodes = Utilities::string_to_int(Utilities::trim(get_line()));
        text << n_nodes << '\n';
        for (int i = 0; i < n_nodes; ++i, text << '\n')
        {
          copy<int>();
          copy<double>(3);
        }
      }

      /** Blocks with a header, type, number of elements and tags; then number, tags and nodes. */
      void convert_elements_of_format_2()
      {
        const std::string count = Utilities::trim(get_line());
        text << count << '\n';
        for (int n_left = Utilities::string_to_int(count); n_left > 0;)
        {
          int header[3];
          AssertThrow(sizeof(header) <= contents.size() - position,
                      ExcMessage("it ends too early."));
          std::memcpy(header, &contents[position], sizeof(header));
          position += sizeof(header);
          const auto [type, n_elements, n_tags] = header;
          AssertThrow(n_elements > 0 && n_elements <= n_left && n_tags >= 0,
                      ExcMessage("it has blocks of elements that can't be."));
          for (int e = 0; e < n_elements; ++e, text << '\n')
          {
            copy<int>();
            text << type << ' ' << n_tags << ' ';
            copy<int>(n_tags + get_n_nodes(type));
          }
          n_left -= n_elements;
        }
      }
    };
  } // namespace

  bool is_binary_mesh(const std::string &contents)
  {
    std::istringstream stream(contents.substr(0, 100));
    std::string        section;
    double             version   = 0;
    int                is_binary = 0;
    stream >> section >> version >> is_binary;
    return section == "$MeshFormat" && is_binary == 1;
  }

  std::string convert_binary_mesh(const std::string &contents)
  {
    return Converter(contents).convert();
  }
} // namespace caudal
