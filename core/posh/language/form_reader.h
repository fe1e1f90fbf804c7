// Reads one form of a plan, from the token after its keyword to its closing parenthesis. `begin` is the place of the
// opening parenthesis. If the text is wrong, each function adds a finding to the cursor and returns false.
#pragma once

#include "core/posh/language/token_cursor.h"

namespace usar::posh {

bool readDocumentation(TokenCursor& cursor, const Spot& begin, Documentation& documentation);
bool readCompetence(TokenCursor& cursor, const Spot& begin, Competence& competence);
bool readPattern(TokenCursor& cursor, const Spot& begin, Pattern& pattern);
bool readAdopt(TokenCursor& cursor, const Spot& begin, Adopt& adopt);
/// The caller has already set `kind` and `keyword` of the collection.
bool readCollection(TokenCursor& cursor, const Spot& begin, Collection& collection);

} // namespace usar::posh
