// Locations of the program's own files: beside the program in a build tree, below the prefix once installed.
#pragma once

#include <cstdint>
#include <optional>

#include <QString>
#include <QStringList>

#include "core/base/result.h"

namespace usar::server {

/// Returns the folder of a world that comes with the program, by the world's name; a text that is the path of a folder
/// is returned unchanged. The error lists the known names, or says what to do if there are no worlds at all.
Result<QString> findWorld(const QString& name_or_folder);
/// Does the same with another folder that contains the worlds.
Result<QString> findWorldIn(const QString& worlds_folder, const QString& name_or_folder);
/// A world that is made when it is wanted, from the name of its generator and a seed.
struct SeededWorld {
    QString generator;
    std::uint64_t seed = 0;
};
/// Reads "town:7". Any other text, such as the path of a folder, is none.
std::optional<SeededWorld> seededWorld(const QString& name);
/// Folder of the worlds that come with the program, and of the measured data that some generators read.
QString worldsFolder();
/// Names of the worlds that come with the program, sorted.
QStringList worldNames();
/// The title of a world for menus: "Point lookout" for "point_lookout".
QString worldTitle(QString name);
/// The folder of the missions that come with the program.
QString missionsFolder();
/// The folder of the campaigns that come with the program.
QString campaignsFolder();
/// The folder of the samples that come with the program: what a flight, a scan and a campaign leave.
QString samplesFolder();
/// The folder of the robot files.
QString robotsFolder();
/// The folder of the files that give a real server the robots' equipment: USARBot.ini and DefaultUSAR.ini.
QString serverFilesFolder();
/// Says what to do about a robot of a real server that lacks sensors, and where the file for it lies.
QString equipmentAdvice();
/// The page for a browser that the Help menu opens; it is not there if the program was built without a Markdown reader.
QString manualPage();
/// Folders that contain behavior plugins, most specific first.
QStringList pluginFolders();
/// Path of the program that flies missions and campaigns without a window.
QString missionProgram();
/// Path of the program that runs behaviors that have a process of their own.
QString behaviorHostProgram();

} // namespace usar::server
