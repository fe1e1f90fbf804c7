#include "widgets/commands/libraries.h"

#include <array>
#include <cstdint>

#include <dlfcn.h>
#include <link.h>

#include <Eigen/Core>
#include <QFileInfo>
#include <QObject>
#include <QStringList>

namespace usar::widgets {

namespace {

/// Names of the files that the loader has mapped, without links: "libz.so.1.2.13".
QStringList loadedFiles() {
    QStringList files;
    dl_iterate_phdr(
        [](dl_phdr_info* info, std::size_t, void* list) {
            const QString path = QFileInfo(QString::fromLocal8Bit(info->dlpi_name)).canonicalFilePath();
            static_cast<QStringList*>(list)->append(QFileInfo(path).fileName());
            return 0;
        },
        &files);
    return files;
}

/// "3.24" for "libBulletDynamics-float64.so.3.24".
QString versionInName(const QString& file) {
    return file.section(QStringLiteral(".so."), 1);
}

/// A function of a loaded library, with which this one need not be linked; nullptr if it has none of this name.
template <class Function>
Function* functionOf(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

QString zlibSays(const QString& file) {
    auto* const version = functionOf<const char*()>("zlibVersion");
    return version ? QString::fromLatin1(version()) : versionInName(file);
}

QString pngSays(const QString& file) {
    auto* const version = functionOf<const char*(const void*)>("png_get_libpng_ver");
    return version ? QString::fromLatin1(version(nullptr)) : versionInName(file);
}

QString sdlSays(const QString& file) {
    auto* const version = functionOf<void(std::array<std::uint8_t, 3>*)>("SDL_GetVersion");
    if (!version)
        return versionInName(file);
    std::array<std::uint8_t, 3> parts{}; // As SDL_version.
    version(&parts);
    return QStringLiteral("%1.%2.%3").arg(parts[0]).arg(parts[1]).arg(parts[2]);
}

QString jpegAtBuildTime(const QString&) {
    return QStringLiteral(USAR_JPEG_VERSION); // It does not tell, and its file has the version of its interface.
}

struct Loadable {
    QString file; ///< how the name of its file begins
    QString (*version)(const QString& file);
    Library library; ///< still without version
};

} // namespace

std::vector<Library> libraries() {
    const std::array<Loadable, 7> loadables{{
        {"libBulletDynamics", versionInName, {"Bullet Physics", {}, "Zlib", QObject::tr("rigid bodies and contacts")}},
        {"libsdformat", versionInName, {"sdformat", {}, "Apache-2.0", QObject::tr("world files")}},
        {"libQCustomPlot", versionInName, {"QCustomPlot", {}, "GPL-3.0-or-later", QObject::tr("plots")}},
        {"libpng", pngSays, {"libpng", {}, "libpng-2.0", QObject::tr("height images")}},
        {"libjpeg", jpegAtBuildTime, {"libjpeg-turbo", {}, "IJG AND BSD-3-Clause", QObject::tr("camera pictures")}},
        {"libz.so", zlibSays, {"zlib", {}, "Zlib", QObject::tr("checksums of recordings")}},
        {"libSDL2", sdlSays, {"SDL", {}, "Zlib", QObject::tr("gamepads")}},
    }};
    std::vector<Library> found{
        {"Qt", QString::fromLatin1(qVersion()), "LGPL-3.0-only", QObject::tr("window, sockets, threads")},
        {"Eigen", QStringLiteral("%1.%2.%3").arg(EIGEN_WORLD_VERSION).arg(EIGEN_MAJOR_VERSION).arg(EIGEN_MINOR_VERSION),
         "MPL-2.0", QObject::tr("vectors and rotations")},
        {"tl::expected", QStringLiteral(USAR_EXPECTED_VERSION), "CC0-1.0", QObject::tr("results that may be errors")}};
    const QStringList files = loadedFiles();
    for (const Loadable& loadable : loadables)
        for (const QString& file : files)
            if (file.startsWith(loadable.file)) {
                found.push_back(loadable.library);
                found.back().version = loadable.version(file);
                break;
            }
    return found;
}

} // namespace usar::widgets
