// Saves the shown lines of traffic to a file, a few milliseconds at a time.
#pragma once

#include <vector>

#include <QObject>
#include <QSaveFile>
#include <QTimer>

#include "widgets/models/messages/message_model.h"

namespace usar::widgets {

/// A name ending in ".jsonl" gets one JSON object per line, any other name the columns separated by tabs. The file
/// appears completely or not at all. Rows that leave the ring while saving are missing in the file, so the list should
/// stand still until then. GUI thread; the model must outlive it.
class MessageSaver : public QObject {
    Q_OBJECT
public:
    explicit MessageSaver(const MessageModel& model, QObject* parent = nullptr);

    /// Starts saving the rows that are shown now. Only one file at a time: a second call while busy emits `failed`.
    void save(const QString& path);
    /// True from a successful `save` to `saved` or `failed`.
    bool busy() const { return file_ != nullptr; }

signals:
    /// The file is complete; `lines` is the number of lines written.
    void saved(const QString& path, int lines);
    /// `reason` is a sentence with the remedy.
    void failed(const QString& reason);

private:
    /// Writes rows for some milliseconds; after the last one the file gets its name.
    void writeSlice();
    /// Ends saving, discards what was written, and emits `failed`.
    void fail();

    const MessageModel& model_;
    std::unique_ptr<QSaveFile> file_;
    /// Serial numbers of the rows to save, as shown when saving began.
    std::vector<std::uint64_t> serials_;
    /// Index in `serials_` of the next row to write.
    std::size_t next_ = 0;
    int written_ = 0;
    QTimer slice_{this};
};

} // namespace usar::widgets
