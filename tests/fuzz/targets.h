#pragma once

#include <string>
#include <string_view>
#include <vector>

/// FuzzTarget::check and FuzzTarget::seeds of each target.
namespace sandbox {

void check_obj(std::string_view bytes);
std::vector<std::string> obj_seeds();
void check_mtl(std::string_view bytes);
std::vector<std::string> mtl_seeds();
void check_png(std::string_view bytes);
std::vector<std::string> png_seeds();
void check_jpeg(std::string_view bytes);
std::vector<std::string> jpeg_seeds();
void check_pfm(std::string_view bytes);
std::vector<std::string> pfm_seeds();
void check_scene(std::string_view bytes);
std::vector<std::string> scene_seeds();
void check_sidecar(std::string_view bytes);
std::vector<std::string> sidecar_seeds();
void check_report(std::string_view bytes);
std::vector<std::string> report_seeds();
void check_taught(std::string_view bytes);
std::vector<std::string> taught_seeds();
void check_settings(std::string_view bytes);
std::vector<std::string> settings_seeds();
void check_own(std::string_view bytes);
std::vector<std::string> own_seeds();
void check_script(std::string_view bytes);
std::vector<std::string> script_seeds();

} // namespace sandbox
