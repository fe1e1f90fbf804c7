// Reads one form of a plan, each from behind its keyword to its closing parenthesis. False, the complaint made, where
// the text is wrong. `begin` is the opening parenthesis.
#pragma once

#include "core/posh/token_cursor.h"

namespace usar::posh {

bool readDocumentation(TokenCursor& cursor, const Spot& begin, Documentation& documentation);
bool readCompetence(TokenCursor& cursor, const Spot& begin, Competence& competence);
bool readPattern(TokenCursor& cursor, const Spot& begin, Pattern& pattern);
bool readAdopt(TokenCursor& cursor, const Spot& begin, Adopt& adopt);
/// `kind` and `keyword` are set already.
bool readCollection(TokenCursor& cursor, const Spot& begin, Collection& collection);

} // namespace usar::posh
