// Reads the small parts of a form: names, values, calls, senses, intervals. Each function begins at the present token
// and returns false, the complaint made, where the text is wrong.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/posh/token_cursor.h"

namespace usar::posh {

/// `whose`: "of the drive", for the complaint.
bool readName(TokenCursor& cursor, std::string_view whose, Name& name);

/// Whether a value (not a bare name) stands here.
bool atValue(const TokenCursor& cursor);
bool readValue(TokenCursor& cursor, Literal& literal);

/// A trailing comment string, if one stands here.
bool readComment(TokenCursor& cursor, std::optional<Literal>& comment);

/// From `vars` on, if it stands here.
bool readFormals(TokenCursor& cursor, std::vector<Formal>& formals);

/// From the opening parenthesis on.
bool readArguments(TokenCursor& cursor, std::vector<Argument>& arguments);
/// A name, and arguments where a parenthesis follows.
bool readCall(TokenCursor& cursor, std::string_view whose, Call& call);

/// `(sense value predicate)`, from the opening parenthesis on.
bool readSenseTest(TokenCursor& cursor, SenseTest& test);
/// `nil` or a list in parentheses.
bool readSenses(TokenCursor& cursor, Senses& senses);
/// `(goal …)`, from the opening parenthesis on.
bool readGoal(TokenCursor& cursor, Senses& goal);

/// `(unit number)`, from the opening parenthesis on; hz, pm and ticks only where rates are allowed.
bool readInterval(TokenCursor& cursor, bool rates_allowed, std::optional<Interval>& interval);

} // namespace usar::posh
