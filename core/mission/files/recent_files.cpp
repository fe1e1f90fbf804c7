#include "core/mission/files/recent_files.h"

#include <algorithm>

#include <QDir>
#include <QFileInfo>

namespace usar::mission {

namespace {

constexpr qsizetype most = 10;

} // namespace

void RecentFiles::add(const QString& path) {
    const QString whole = QDir::cleanPath(QFileInfo(path).absoluteFilePath());
    paths_.removeAll(whole);
    paths_.prepend(whole);
    paths_.resize(std::min(paths_.size(), most));
}

QStringList RecentFiles::existing() const {
    QStringList there = paths_;
    there.removeIf([](const QString& path) { return !QFileInfo::exists(path); });
    return there;
}

void RecentFiles::restore(const QStringList& paths) {
    paths_ = paths.first(std::min(paths.size(), most));
}

} // namespace usar::mission
