// Where the program's own files are: beside the program in a build tree, below the prefix once installed.
#pragma once

#include <QString>
#include <QStringList>

#include "core/base/result.h"

namespace usar::server {

/// The folder of this name among the worlds that come with the program, or the text itself where it names a folder.
/// The error lists the names that are there, or says what to do where there are none.
Result<QString> findWorld(const QString& name_or_folder);
/// The same with another folder for the worlds.
Result<QString> findWorldIn(const QString& worlds_folder, const QString& name_or_folder);
/// Those that come with the program, by name.
QStringList worldNames();
/// The folder of the robot files.
QString robotsFolder();
/// Folders that hold behavior plugins, most specific first.
QStringList pluginFolders();
/// The program that behaviors run in where they have a process of their own.
QString behaviorHostProgram();

} // namespace usar::server
