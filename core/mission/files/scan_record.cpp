#include "core/mission/files/scan_record.h"

namespace usar::mission {

QString numberText(double value) {
    return QString::number(value, 'g', 12);
}

QStringList textsOf(const std::vector<std::string>& texts) {
    QStringList converted;
    for (const std::string& text : texts)
        converted << QString::fromStdString(text);
    return converted;
}

std::vector<std::pair<QString, QString>> metadataOf(const ScanRecord& record) {
    const mapping::Raster& raster = record.raster;
    std::vector<std::pair<QString, QString>> data{
        {"level", QString::fromStdString(record.level)},
        {"robot", QString::fromStdString(record.robot_name)},
        {"behavior", QString::fromStdString(record.behavior_id)},
        {"axes", "columns along +x (forward), rows along -y (y is left), heights along +z (up)"},
        {"units", "m"},
        {"cell_size_m", numberText(raster.cell_size_m)},
        {"upper_left_center_x_m", numberText(raster.upper_left_center_m.x())},
        {"upper_left_center_y_m", numberText(raster.upper_left_center_m.y())}};
    if (!record.faults.empty())
        data.emplace_back("faults", textsOf(record.faults).join("; "));
    if (const auto range = raster.range()) {
        data.emplace_back("minimum_m", numberText(double(range->minimum_m)));
        data.emplace_back("maximum_m", numberText(double(range->maximum_m)));
    }
    return data;
}

} // namespace usar::mission
