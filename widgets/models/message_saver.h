// Writes the shown lines of traffic to a file, a few milliseconds at a time.
#pragma once

#include <vector>

#include <QObject>
#include <QSaveFile>
#include <QTimer>

#include "widgets/models/message_model.h"

namespace usar::widgets {

/// `.jsonl` gets one JSON object a line, any other name the columns with tabs between. The file appears whole or not at
/// all. What falls out of the ring meanwhile is left out and counted, so hold the list while it runs. GUI thread.
class MessageSaver : public QObject {
    Q_OBJECT
public:
    explicit MessageSaver(const MessageModel& model, QObject* parent = nullptr);

    /// Takes down which rows are shown now; one file at a time, a second call while busy is refused with `failed`.
    void save(const QString& path);
    bool busy() const { return file_ != nullptr; }

signals:
    void saved(const QString& path, int lines);
    void failed(const QString& reason);

private:
    void writeSlice();
    void fail();

    const MessageModel& model_;
    std::unique_ptr<QSaveFile> file_;
    std::vector<std::uint64_t> serials_;
    std::size_t next_ = 0;
    int written_ = 0;
    QTimer slice_{this};
};

} // namespace usar::widgets
