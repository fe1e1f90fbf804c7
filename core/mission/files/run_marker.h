// A mark on the disk that says that the program runs, by which its next start knows what a crash left behind.
#pragma once

#include <QLockFile>
#include <QString>
#include <QStringList>

namespace usar::mission {

/// Marks this process in a folder from construction to destruction, beside the marks of other processes. A process that
/// is killed leaves its mark, and the system knows that it is gone. A folder that cannot be written has no marks.
class RunMarker {
public:
    explicit RunMarker(const QString& folder);
    ~RunMarker();
    Q_DISABLE_COPY_MOVE(RunMarker)

    /// Replaces the full paths of the recordings that are being written. To be called by one thread at a time.
    void setRecordings(const QStringList& paths) const;

    /// Returns the recordings that processes of this folder left without an orderly end, as far as the files exist, and
    /// removes the marks of these processes: the next call returns nothing of them.
    static QStringList takeAbandoned(const QString& folder);

private:
    QString stem_; ///< path of the mark without its endings
    QLockFile process_;
};

} // namespace usar::mission
