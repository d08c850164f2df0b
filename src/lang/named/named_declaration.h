#pragma once
// NamedDeclarations: reads DEF, DEFINE, PROC and EXTERN (spec/sinumerik 6.1, 9.2). Base of the reader of blocks with names.

#include <string>
#include <vector>

#include "lang/named/named_expression.h"

namespace kadr {

class NamedDeclarations : public NamedExpressions {
 public:
  using NamedExpressions::NamedExpressions;

 protected:
  /// Reads the rest of the block after one of these keywords.
  Status declaration(const std::string& keyword);

 private:
  Status parameters(bool named);
  /// Reads the sizes of an array parameter, F[2] or F[].
  Status open_indices(std::vector<NamedExpression>& to);
  Status macro();
  Result<bool> modifier();
  Status modifiers();
  Status definition();
  Status initial_values(NamedDefinition& row);

  std::vector<NamedExpression> ignored_;
};

}  // namespace kadr
