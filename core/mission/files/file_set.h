// The files of one scan: they have a stem in common, and an error says why one of them was not written.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>

#include <QByteArray>
#include <QImage>
#include <QSaveFile>
#include <QString>
#include <QStringList>

#include "core/base/result.h"
#include "core/mapping/byte_stream.h"
#include "core/mission/files/scan_record.h"

namespace usar::mission {

/// The mend for a folder into which nothing can be written.
inline constexpr char folder_mend[] = "Choose another folder, or make this one writable and save again";

/// Saving into the folder was cancelled.
Error cancelledIn(const QString& folder);

/// Returns the first stem with which no file in the folder begins: USAR_Scan_<level>_<robot>_<number>.
QString freeStem(const QString& folder, const ScanRecord& record);

/// Makes the folder and calls `write` while no other saving of this or another program into it can take the same
/// names; waits for others up to a minute, or until `stop` is requested. Fails where nothing can be written.
Result<QStringList> withLockedFolder(const QString& folder, const std::stop_token& stop,
                                     const std::function<Result<QStringList>()>& write);

/// Writes files into a folder, each under a temporary name that is then changed to its own; stops at the first failure,
/// or when it is told to. To be used in one thread, outside the GUI's.
class FileSet {
public:
    /// A request to stop removes all files that are complete already.
    FileSet(QString folder, QString stem, std::stop_token stop);

    // `ending` is what comes after the stem: "_picture.png".
    void bytes(const QString& ending, const char* data, qsizetype size);
    void bytes(const QString& ending, const QByteArray& data) { bytes(ending, data.constData(), data.size()); }
    void image(const QString& ending, const QImage& picture);
    /// `write` sends the file piece by piece, and returns false as soon as a piece is not taken.
    void stream(const QString& ending, const std::function<bool(const mapping::ByteSink&)>& write);

    QString pathOf(const QString& ending) const;
    const QStringList& files() const { return files_; }
    const std::optional<Error>& error() const { return error_; }
    /// True after an error or a request to stop; what comes next need not even be prepared.
    bool stopped();
    const std::stop_token& stopToken() const { return stop_; } ///< for what takes long to prepare

private:
    void save(const QString& ending, const std::function<bool(QSaveFile&)>& write);

    QString folder_;
    QString stem_;
    std::stop_token stop_;
    QStringList files_;
    std::optional<Error> error_;
};

} // namespace usar::mission
