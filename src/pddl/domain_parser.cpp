// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <string>

#include "action_reader.h"
#include "declaration_reader.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/quote.h"
#include "goal_alignment/pddl/parser.h"

namespace goal_alignment::pddl {

namespace {

const Sections kSections{
    {":requirements", ":types", ":constants", ":predicates", ":functions", ":action"},
    "a section of a domain, such as ':action'"};

/// (define (domain name) section …), the sections in any order: nothing is looked up before
/// linking, so none needs to stand before another.
class DomainParser {
 public:
  DomainParser(const Source& source, const Limits& limits)
      : source_(std::make_shared<const Source>(source)), reader_(*source_, limits) {
    domain_.source = source_;
  }

  ast::Domain parse() {
    domain_.name = readHeader(reader_, "domain");
    while (!reader_.atClose()) {
      reader_.open("'(' or ')'");
      readSection();
      reader_.close();
    }
    reader_.close();
    reader_.finish();
    return std::move(domain_);
  }

 private:
  void readSection() {
    reader_.setPlace("domain " + inQuotes(domain_.name.spelling));
    expectSection(reader_, kSections);
    // Actions alone come as often as they like.
    if (!reader_.atWord(":action")) log_.note(reader_);
    const std::string keyword = toLower(reader_.word("a section").text);
    reader_.setPlace(keyword);
    if (keyword == ":requirements") {
      domain_.requirements = readRequirements(reader_);
    } else if (keyword == ":types") {
      domain_.types = readTypedList(reader_, ListOf::Types, "a type");
    } else if (keyword == ":constants") {
      domain_.constants = readTypedList(reader_, ListOf::Names, "an object");
    } else if (keyword == ":predicates") {
      domain_.predicates = readPredicates(reader_);
    } else if (keyword == ":functions") {
      domain_.functions = readFunctions(reader_);
    } else {
      domain_.actions.push_back(readAction(reader_));
    }
  }

  std::shared_ptr<const Source> source_;
  TokenReader reader_;
  ast::Domain domain_;
  SectionLog log_;
};

}  // namespace

ast::Domain parseDomain(const Source& source, const Limits& limits) {
  return DomainParser(source, limits).parse();
}

}  // namespace goal_alignment::pddl
