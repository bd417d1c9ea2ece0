// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_batch_h
#define caudal_passage_batch_h

#include <caudal/passage/column.h>
#include <caudal/passage/question.h>

namespace caudal::passage
{
  /** A row of the table of fish. */
  struct BatchFish
  {
    std::string species;
    double      length; // [m]
    std::string place;  // where its row stands, for messages
  };

  /** Section `Batch`: many fish at once. */
  struct BatchParameters
  {
    std::string file;
    std::string species_column = "species";
    Column      length{"length", "length", length_units, "m"};

    void add_parameters(ParameterHandler &prm);

    /** Throws a sentence if the law does not know one of the fish. */
    void check(const EnduranceLaw &law) const;

    bool is_asked_for() const
    {
      return !file.empty();
    }

    std::vector<BatchFish> read() const;
  };

  /** The answer for one kind of fish at one discharge. */
  struct BatchAnswer
  {
    BatchFish   fish;
    double      discharge; // [m^3/s]
    double      share;     // that passes [1]
    double      fatigue;   // of the median fish [1]
    Cause       cause;     // why too few pass, if fewer do than 87.5 %
    double      place;     // where [m]
    std::string remark;    // on the limits of the data
  };

  /** Answers each fish at each discharge. */
  std::vector<BatchAnswer> answer_batch(const BatchParameters &parameters, const Question &question,
                                        const std::vector<Waterway> &waterways);
} // namespace caudal::passage

#endif
