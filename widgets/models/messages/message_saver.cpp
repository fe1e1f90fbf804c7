#include "widgets/models/messages/message_saver.h"

#include <QElapsedTimer>
#include <QJsonDocument>

#include "widgets/models/messages/message_parts.h"

namespace usar::widgets {

namespace {

constexpr qint64 writing_ms = 10;

} // namespace

MessageSaver::MessageSaver(const MessageModel& model, QObject* parent) : QObject(parent), model_(model) {
    slice_.setInterval(0);
    connect(&slice_, &QTimer::timeout, this, &MessageSaver::writeSlice);
}

void MessageSaver::save(const QString& path) {
    if (busy()) {
        emit failed(tr("%1 is still being saved. Save again when it is done.").arg(file_->fileName()));
        return;
    }
    file_ = std::make_unique<QSaveFile>(path);
    if (!file_->open(QIODevice::WriteOnly))
        return fail();
    serials_.clear();
    for (int row = 0; row < model_.rowCount(); ++row)
        serials_.push_back(model_.serial(row));
    next_ = 0;
    written_ = 0;
    slice_.start();
}

void MessageSaver::writeSlice() {
    const bool as_json = file_->fileName().endsWith(QStringLiteral(".jsonl"), Qt::CaseInsensitive);
    QElapsedTimer timer;
    timer.start();
    QByteArray bytes;
    for (; next_ < serials_.size() && timer.elapsed() < writing_ms; ++next_) {
        const MessageRow* row = model_.find(serials_[next_]);
        if (!row)
            continue;
        const QString robot = model_.connectionName(row->connection);
        bytes += as_json ? QJsonDocument(jsonOf(*row, robot)).toJson(QJsonDocument::Compact)
                         : tabbedText(*row, robot).toUtf8();
        bytes += '\n';
        ++written_;
    }
    if (file_->write(bytes) != bytes.size())
        return fail();
    if (next_ < serials_.size())
        return;
    slice_.stop();
    if (!file_->commit())
        return fail();
    const QString path = file_->fileName();
    file_.reset();
    emit saved(path, written_);
}

void MessageSaver::fail() {
    slice_.stop();
    const QString reason = tr("Cannot save %1: %2. Choose another folder or free some space.")
                               .arg(file_->fileName(), file_->errorString());
    file_.reset();
    emit failed(reason);
}

} // namespace usar::widgets
