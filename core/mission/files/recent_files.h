// The files that were opened or saved last.
#pragma once

#include <QString>
#include <QStringList>

namespace usar::mission {

/// Paths of the ten files that were used last, newest first, each once.
class RecentFiles {
public:
    /// Puts a file first; `path` may be relative to the working folder.
    void add(const QString& path);
    /// Those that are still there. Looks at the disk.
    QStringList existing() const;
    /// All of them, as `restore` takes them.
    const QStringList& all() const { return paths_; }
    void restore(const QStringList& paths);

private:
    QStringList paths_; ///< absolute
};

} // namespace usar::mission
