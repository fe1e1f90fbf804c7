// Where the program's own files are: beside the program in a build tree, below the prefix once installed.
#pragma once

#include <QString>
#include <QStringList>

namespace usar::app {

/// A folder with this name under the worlds that come with the program, or the text itself where it names a folder.
QString worldFolder(const QString& name_or_folder);
/// Names of the worlds that come with the program.
QStringList worldNames();
/// Folders that hold behavior plugins, most specific first.
QStringList pluginFolders();

} // namespace usar::app
