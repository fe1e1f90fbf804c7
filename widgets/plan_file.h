// The file of a plan that is edited: read and written without harm, watched, and kept aside while it is not saved.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include "core/base/result.h"

namespace usar::widgets {

/// Texts are UTF-8 with LF; a file with CR LF or a byte-order mark gets them back when it is saved. GUI thread.
class PlanFile : public QObject {
    Q_OBJECT
public:
    explicit PlanFile(QObject* parent = nullptr);

    /// Its text; this is the file from now on.
    Result<std::string> open(const QString& path);
    /// Replaced at once or not at all; this is the file from now on.
    Result<void> save(const QString& path, std::string_view text);
    /// No file yet; a name for people all the same. The text counts as saved.
    void startNew(const QString& name, std::string_view text);
    const QString& path() const { return path_; }
    /// Without its folder.
    QString name() const;
    /// As it was read or written last.
    const std::string& savedText() const { return saved_; }

    /// Where texts that were not saved are kept. Without a folder they are not.
    void setKeepingFolder(const QString& folder) { folder_ = folder; }
    /// Soon, and once for many calls.
    void keep(std::string_view text);
    /// What was kept of this file when the program ended without saving, if it is another text.
    std::optional<std::string> kept() const;
    void forgetKept();

signals:
    /// By somebody else; not when it holds what it held.
    void changedOnDisk(const std::string& text);

private:
    QString keptPath() const;
    void writeKept();
    void look();
    void watch();

    QString path_;
    QString new_name_;
    std::string saved_;
    bool has_crlf_ = false;
    bool has_mark_ = false;
    QString folder_;
    std::string to_keep_;
    QTimer keep_timer_;
    QTimer look_timer_;
    QFileSystemWatcher watcher_;
};

} // namespace usar::widgets
