#pragma once

// NoServices: an application that does nothing. Tests derive from it and override what they look at.

#include "ui/files/export_settings.hpp"
#include "ui/files/picture_order.hpp"
#include "ui/widgets/application_services.hpp"

namespace hariko::test {

class NoServices : public ApplicationServices {
 public:
  void open(const std::filesystem::path&) override {}
  void import_file(const std::filesystem::path&) override {}
  void drop_files(const std::vector<std::filesystem::path>&) override {}
  void save(const std::filesystem::path&, std::function<void()>) override {}
  void save_copy(const std::filesystem::path&) override {}
  void revert() override {}
  void recover(const std::string&) override {}
  void discard_recovery(const std::string&) override {}
  void dismiss_crash() override {}
  void show_log_folder() override {}
  void export_file(const std::filesystem::path&, const ExportSettings&) override {}
  void count_export(const std::filesystem::path&, const ExportSettings&) override {}
  void export_cad(const std::filesystem::path&, const CadSettings&) override {}
  void count_cad(const CadSettings&) override {}
  void cancel_count() override {}
  void export_pictures(PictureOrder) override {}
  void export_drawing(DrawingOrder) override {}
  void export_sections(SectionOrder) override {}
  void export_control(const std::filesystem::path&) override {}
  void export_pages(const std::filesystem::path&) override {}
  void add_pictures(const std::vector<std::filesystem::path>&) override {}
  void pack_pictures(const std::vector<ObjectId>&) override {}
  void unpack_picture(ObjectId, const std::filesystem::path&) override {}
  void replace_picture(ObjectId, const std::filesystem::path&) override {}
  void find_pictures(const std::filesystem::path&) override {}
  void convert(ObjectId) override {}
  void add_section(ObjectId, double) override {}
  void record(const std::filesystem::path&) override {}
  void stop_recording() override {}
  void record_script(const std::filesystem::path&) override {}
  void stop_script() override {}
  void give_picture(Sample&) override {}
  void quit() override {}
};

}  // namespace hariko::test
