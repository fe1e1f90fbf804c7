#include "core/mission/reports/export_verb.h"

#include <utility>

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/mission/files/export_options.h"
#include "core/mission/runs/export_source.h"
#include "core/mission/runs/mission_runner.h"

namespace usar::mission {

namespace {

/// All formats that the source can give and whose files are not in the folder yet.
FormatList formatsToAdd(const ExportSource& source, const QString& folder) {
    FormatList list;
    for (const MapFormat& format : mapFormats())
        if (checkPoints({&format}, source.record) &&
            !QFileInfo::exists(QDir(folder).filePath(source.stem + '.' + format.id)))
            list.push_back(&format);
    return list;
}

Result<QStringList> exported(const ExportOptions& options, const VerbStreams& streams) {
    const auto source = openExportSource(options.result, options.formats.empty() || needPoints(options.formats));
    if (!source)
        return tl::unexpected(source.error());
    if (!source->missing.empty())
        streams.complain(source->missing + " The map lacks what was scanned there.");
    const QString folder = options.folder.isEmpty() ? source->folder : options.folder;
    const FormatList formats = options.formats.empty() ? formatsToAdd(*source, folder) : options.formats;
    if (formats.empty())
        return failure("the folder has the map in every format already", folder.toStdString(),
                       "Choose another folder with --out");
    return exportMap(source->record, formats, folder, source->stem);
}

} // namespace

bool isExportVerb(const QString& word) {
    return word == "export";
}

int runExportVerb(const QStringList& arguments, const VerbStreams& streams) {
    const auto options = readExportOptions(arguments);
    const Result<QStringList> files =
        options ? exported(*options, streams) : Result<QStringList>(tl::unexpect, options.error());
    const std::string trouble = files ? std::string() : files.error().text();
    if (!files)
        streams.complain(trouble);
    const QJsonObject summary{{"success", files.has_value()},
                              {"reason", QString::fromStdString(trouble)},
                              {"files", QJsonArray::fromStringList(files.value_or(QStringList()))}};
    streams.output.write(QJsonDocument(summary).toJson(QJsonDocument::Compact) + '\n');
    return files ? Done : BadInput;
}

} // namespace usar::mission
