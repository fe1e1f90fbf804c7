// The project's own #include lines, as data.
#pragma once

#include <map>
#include <vector>

#include <QString>
#include <QStringList>

struct Include {
    QString file; ///< from the root: "core/protocol/reader.h"
    int line = 0;
    QString target; ///< as written
    bool angled = false;
};

/// Every #include of the C++ files below the named top-level folders of `root`.
std::vector<Include> includesBelow(const QString& root, const QStringList& folders);

/// Who depends on whom: "core/protocol", "robots/airrobot", "app" ….
QString folderOf(const QString& file);

/// Files that lie on a cycle of includes; empty when there is none.
QStringList includeCycle(const std::vector<Include>& includes);

/// DEPENDS of every usar_add_module in the CMakeLists below `folders`: module name to what it links.
std::map<QString, QStringList> moduleDependencies(const QString& root, const QStringList& folders);
