// Which libraries the program has loaded, with versions and licenses.
#pragma once

#include <vector>

#include <QString>

namespace usar::widgets {

struct Library {
    QString name;
    QString version; ///< what the loaded library says itself; else what its file says, or the headers at build time
    QString license; ///< as SPDX writes it
    QString use;     ///< "world files"
};

/// The libraries that are loaded now, and those that are compiled in; Qt comes first. Those of which no version can be
/// found have none.
std::vector<Library> libraries();

} // namespace usar::widgets
