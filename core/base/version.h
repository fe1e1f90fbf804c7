// The version of the programs, and their answer to --version.
#pragma once

#include <string_view>

namespace usar {

/// Such as "0.1.0".
std::string_view version();
/// Prints the program's name and version if --version or -v is among the arguments of `main`; returns whether it was.
bool answersVersion(int argc, const char* const* argv);

} // namespace usar
