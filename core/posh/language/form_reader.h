// Reads the forms of a plan and their small parts: names, values, calls, senses, intervals. Each read function begins
// at the current token and moves past what it reads. If the text is wrong, it adds a finding to the cursor and returns
// false.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/posh/language/token_cursor.h"

namespace usar::posh {

// These read one form, from the token after its keyword to its closing parenthesis. `begin` is the place of the opening
// parenthesis.

bool readDocumentation(TokenCursor& cursor, const Spot& begin, Documentation& documentation);
bool readCompetence(TokenCursor& cursor, const Spot& begin, Competence& competence);
bool readPattern(TokenCursor& cursor, const Spot& begin, Pattern& pattern);
bool readAdopt(TokenCursor& cursor, const Spot& begin, Adopt& adopt);
/// The caller has already set `kind` and `keyword` of the collection.
bool readCollection(TokenCursor& cursor, const Spot& begin, Collection& collection);

// The small parts, which are defined in call_reader.cpp.

/// Reads a name. `whose` completes the error message: "of the drive".
bool readName(TokenCursor& cursor, std::string_view whose, Name& name);

/// Returns whether the current token is a value. A bare name is not.
bool atValue(const TokenCursor& cursor);
bool readValue(TokenCursor& cursor, Literal& literal);

/// Reads a trailing comment string, if there is one.
bool readComment(TokenCursor& cursor, std::optional<Literal>& comment);

/// Reads `vars($name=value)`, if the current token is `vars`.
bool readFormals(TokenCursor& cursor, std::vector<Formal>& formals);

/// Reads arguments, beginning at the opening parenthesis.
bool readArguments(TokenCursor& cursor, std::vector<Argument>& arguments);
/// Reads a name, and arguments if a parenthesis follows it.
bool readCall(TokenCursor& cursor, std::string_view whose, Call& call);

/// Reads `(sense value predicate)`, beginning at the opening parenthesis.
bool readSenseTest(TokenCursor& cursor, SenseTest& test);
/// Reads `nil` or a list of senses in parentheses.
bool readSenses(TokenCursor& cursor, Senses& senses);
/// Reads `(goal …)`, beginning at the opening parenthesis.
bool readGoal(TokenCursor& cursor, Senses& goal);

/// Reads `(unit number)`, beginning at the opening parenthesis. The units hz, pm and ticks are errors unless rates are
/// allowed.
bool readInterval(TokenCursor& cursor, bool rates_allowed, std::optional<Interval>& interval);

} // namespace usar::posh
